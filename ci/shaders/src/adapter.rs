//! WGSL over arrays of numbers, on whatever adapter the machine has.

use std::fmt::Write;

/// A device with its queue.
pub struct Adapter {
    pub name: String,
    device: wgpu::Device,
    queue: wgpu::Queue,
}

/// Invocations of a work group.
const GROUP: usize = 64;

impl Adapter {
    /// The machine's adapter, a software one if there is no other; why there is none.
    pub fn open() -> Result<Self, String> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let options = wgpu::RequestAdapterOptions::default();
        let adapter = pollster::block_on(instance.request_adapter(&options)).map_err(|e| e.to_string())?;
        let name = format!("{} ({})", adapter.get_info().name, adapter.get_info().driver_info);
        let found = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()));
        // An adapter that gives no device is broken, not absent.
        let (device, queue) = found.expect("the adapter gives a device");
        Ok(Adapter { name, device, queue })
    }

    /// `expression` for every row of `rows`, in which x0, x1, … are the row's numbers.
    pub fn run<const N: usize>(&self, code: &str, expression: &str, rows: &[[f32; N]]) -> Vec<f32> {
        let mut shader = format!(
            "{code}\n@group(0) @binding(0) var<storage, read> input: array<f32>;\n\
             @group(0) @binding(1) var<storage, read_write> output: array<f32>;\n\
             @compute @workgroup_size({GROUP})\nfn main(@builtin(global_invocation_id) id: vec3<u32>) {{\n    \
             if (id.x >= arrayLength(&output)) {{ return; }}\n"
        );
        for i in 0..N {
            let _ = writeln!(shader, "    let x{i} = input[{N}u * id.x + {i}u];");
        }
        let _ = writeln!(shader, "    output[id.x] = {expression};\n}}");
        let source = wgpu::ShaderSource::Wgsl(shader.into());
        let module = self.device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source });
        let pipeline = self.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: None,
            layout: None,
            module: &module,
            entry_point: Some("main"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        let bytes: &[u8] = bytemuck::cast_slice(rows);
        let size = (rows.len() * size_of::<f32>()) as u64;
        let buffer = |size, usage| {
            self.device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size,
                usage,
                mapped_at_creation: false,
            })
        };
        let (storage, copy) = (wgpu::BufferUsages::STORAGE, wgpu::BufferUsages::COPY_DST);
        let input = buffer(bytes.len() as u64, storage | copy);
        let output = buffer(size, storage | wgpu::BufferUsages::COPY_SRC);
        let back = buffer(size, wgpu::BufferUsages::MAP_READ | copy);
        self.queue.write_buffer(&input, 0, bytes);
        let group = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(0),
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: input.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: output.as_entire_binding() },
            ],
        });
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&pipeline);
            pass.set_bind_group(0, &group, &[]);
            pass.dispatch_workgroups(rows.len().div_ceil(GROUP) as u32, 1, 1);
        }
        encoder.copy_buffer_to_buffer(&output, 0, &back, 0, size);
        self.queue.submit([encoder.finish()]);
        back.map_async(wgpu::MapMode::Read, .., |result| result.expect("the buffer is mapped"));
        self.device.poll(wgpu::PollType::wait_indefinitely()).expect("the device answers");
        let view = back.get_mapped_range(..).expect("a mapped buffer");
        bytemuck::cast_slice(&view).to_vec()
    }
}
