# What an independent renderer, Blender's Cycles, says of chapter 11's lobes: writes cycles.csv, which cycles_stability_test.cpp
# compares with ours. Run by hand, only when the list below changes; with Debian 12's blender (3.4.1) in a minute:
#   blender -b --factory-startup -noaudio -t 2 --python-exit-code 1 -P tests/11_textures/cycles.py -- FILE
# A plate in z = 0 is lit by a point lamp in the direction l and seen from v by parallel rays: what is seen is f·cos
# of l, in single precision. Four seeds give its mean and the standard error of that. Left out is what Cycles has in
# another form: rough glass takes Fresnel's part at the surface's normal, coloured metal has another F, and there is
# no coat like ours.
import array, math, os, sys, tempfile
import bpy
from mathutils import Matrix, Vector

lamp_distance = 10.0
seen_width = 1e-5  # of the plate, in the picture: over it the direction to the lamp turns by 1e-6
seeds = range(1, 5)
models = [('matte', [0, 0.3, 0.7, 1]), ('metal', [0.3, 0.5, 0.8, 1]), ('velvet', [0.2, 0.5, 1])]
light_angles, viewer_angles, turns = [5, 20, 60, 85, 88], [20, 60, 85], [0, 70, 180]


def settings(scene):
    scene.render.engine = 'CYCLES'
    for name, value in dict(device='CPU', samples=16, use_adaptive_sampling=False, use_denoising=False,
                            sampling_pattern='SOBOL', light_sampling_threshold=0, sample_clamp_direct=0,
                            sample_clamp_indirect=0, blur_glossy=0, max_bounces=0, pixel_filter_type='BOX',
                            use_auto_tile=False).items():
        setattr(scene.cycles, name, value)
    render = scene.render
    render.resolution_x = render.resolution_y = 4
    render.resolution_percentage = 100
    render.use_compositing = render.use_sequencer = False
    render.use_persistent_data = True
    file = render.image_settings
    file.file_format, file.color_mode, file.color_depth, file.exr_codec = 'OPEN_EXR', 'RGB', '32', 'NONE'


def plate(scene):
    mesh = bpy.data.meshes.new('plate')
    # The middle of the picture is not on the edge between two triangles.
    mesh.from_pydata([(-3, -2, 0), (2, -2, 0), (2, 3, 0), (-3, 3, 0)], [], [(0, 1, 2, 3)])
    mesh.materials.append(bpy.data.materials.new('lobe'))
    scene.collection.objects.link(bpy.data.objects.new('plate', mesh))
    return mesh.materials[0]


def give(material, model, value):
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    kind = {'matte': 'ShaderNodeBsdfDiffuse', 'metal': 'ShaderNodeBsdfGlossy', 'velvet': 'ShaderNodeBsdfVelvet'}
    node = tree.nodes.new(kind[model])
    node.inputs['Color'].default_value = (1, 1, 1, 1)
    node.inputs['Sigma' if model == 'velvet' else 'Roughness'].default_value = value
    if model == 'metal':
        node.distribution = 'GGX'
    output = tree.nodes.new('ShaderNodeOutputMaterial')
    tree.links.new(node.outputs[0], output.inputs['Surface'])


def added(scene, data):
    thing = bpy.data.objects.new('thing', data)
    scene.collection.objects.link(thing)
    return thing


def towards(theta, phi):
    t, p = math.radians(theta), math.radians(phi)
    return Vector((math.sin(t) * math.cos(p), math.sin(t) * math.sin(p), math.cos(t)))


def look_from(camera, v):
    x = Vector((0, 1, 0)).cross(v).normalized()
    y = v.cross(x)
    eye = v * lamp_distance
    camera.matrix_world = Matrix([(x[i], y[i], v[i], eye[i]) for i in range(3)] + [(0, 0, 0, 1)])


def mean_of_picture(scene, path):
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(path, check_existing=False)
    image.colorspace_settings.name = 'Non-Color'
    values = array.array('f', bytes(4 * 4 * image.size[0] * image.size[1]))
    image.pixels.foreach_get(values)
    bpy.data.images.remove(image)
    red = values[0::4]
    return math.fsum(red) / len(red)


def main(file):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    settings(scene)
    material = plate(scene)
    camera = added(scene, bpy.data.cameras.new('camera'))
    camera.data.type, camera.data.ortho_scale, camera.data.clip_start = 'ORTHO', seen_width, 1e-3
    scene.camera = camera
    lamp = added(scene, bpy.data.lights.new('lamp', 'POINT'))
    lamp.data.energy = 4 * math.pi * math.pi * lamp_distance ** 2  # so that π·f·cos is seen
    lamp.data.shadow_soft_size = 0
    lines = ['lobe,roughness,light_degrees,viewer_degrees,turn_degrees,f_cos,standard_error']
    with tempfile.TemporaryDirectory() as place:
        for model, values in models:
            for value in values:
                give(material, model, value)
                for light in light_angles:
                    lamp.location = towards(light, 0) * lamp_distance
                    for viewer in viewer_angles:
                        for turn in turns:
                            look_from(camera, towards(viewer, turn))
                            seen = []
                            for seed in seeds:
                                scene.cycles.seed = seed
                                seen.append(mean_of_picture(scene, os.path.join(place, 'seen.exr')) / math.pi)
                            mean = math.fsum(seen) / len(seen)
                            error = math.sqrt(math.fsum((x - mean) ** 2 for x in seen) / len(seen) / (len(seen) - 1))
                            lines.append(f'{model},{value},{light},{viewer},{turn},{mean:.8g},{error:.1e}')
    with open(file, 'w') as out:
        out.write('\n'.join(lines) + '\n')


main(sys.argv[sys.argv.index('--') + 1])
