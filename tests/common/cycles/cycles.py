# What an independent renderer, Blender's Cycles, draws of the scenes in this folder: writes NAME.pfm, the mean of
# eight pictures with other random numbers, and NAME.error.pfm, the standard error of that, which cycles_test.cpp
# compares with ours. Run by hand, only when a scene changes; with Debian 12's blender (3.4.1) in a minute:
#   blender -b --factory-startup -noaudio -t 2 --python-exit-code 1 -P tests/common/cycles/cycles.py -- FOLDER
# The same seeds give the same bytes. Below each scene stands what it is in Cycles' words; lengths, directions and
# colours are those of NAME.scene.
import array, math, os, sys, tempfile
import bpy
from mathutils import Matrix, Vector

width, height, samples, seeds = 32, 24, 256, range(1, 9)


def settings(scene):
    scene.render.engine = 'CYCLES'
    for name, value in dict(device='CPU', samples=samples, use_adaptive_sampling=False, use_denoising=False,
                            sampling_pattern='SOBOL', light_sampling_threshold=0, sample_clamp_direct=0,
                            sample_clamp_indirect=0, blur_glossy=0, max_bounces=0, diffuse_bounces=0,
                            glossy_bounces=0, transmission_bounces=0, pixel_filter_type='BOX',
                            use_auto_tile=False).items():
        setattr(scene.cycles, name, value)
    render = scene.render
    render.resolution_x, render.resolution_y, render.resolution_percentage = width, height, 100
    render.use_compositing = render.use_sequencer = render.use_motion_blur = False
    file = render.image_settings
    file.file_format, file.color_mode, file.color_depth, file.exr_codec = 'OPEN_EXR', 'RGB', '32', 'NONE'


def added(data, place=(0, 0, 0)):
    thing = bpy.data.objects.new('thing', data)
    bpy.context.scene.collection.objects.link(thing)
    thing.location = place
    return thing


def camera(eye, at, angle, lens=None):
    data = bpy.data.cameras.new('camera')
    data.sensor_fit, data.sensor_height = 'VERTICAL', 24
    data.lens = 12 / math.tan(math.radians(angle) / 2)
    data.clip_start, data.clip_end = 1e-3, 1e4
    if lens:
        data.dof.use_dof = True
        data.dof.aperture_fstop, data.dof.focus_distance = data.lens * 1e-3 / (2 * lens[0]), lens[1]
    w = (Vector(eye) - Vector(at)).normalized()
    u = Vector((0, 1, 0)).cross(w).normalized()
    v = w.cross(u)
    thing = added(data)
    thing.matrix_world = Matrix([(u[i], v[i], w[i], eye[i]) for i in range(3)] + [(0, 0, 0, 1)])
    bpy.context.scene.camera = thing


def background(color):
    world = bpy.data.worlds.new('world')
    bpy.context.scene.world = world
    world.use_nodes = True
    world.node_tree.nodes['Background'].inputs['Color'].default_value = (*color, 1)


def material(kind, color, **inputs):
    made = bpy.data.materials.new(kind)
    made.use_nodes = True
    tree = made.node_tree
    tree.nodes.clear()
    node = tree.nodes.new('ShaderNode' + kind)
    node.inputs['Color'].default_value = (*color, 1)
    for name, value in inputs.items():
        node.inputs[name].default_value = value
    if kind == 'BsdfGlossy':
        node.distribution = 'GGX'
    tree.links.new(node.outputs[0], tree.nodes.new('ShaderNodeOutputMaterial').inputs['Surface'])
    return made


def matte(*color):
    return material('BsdfDiffuse', color)


def shining(*color):
    return material('Emission', color)


def ggx(alpha, *color):  # the mirror of roughness √α, Fresnel's part left out
    return material('BsdfGlossy', color, Roughness=math.sqrt(alpha))


def floor(made, half=60):
    mesh = bpy.data.meshes.new('floor')
    # No pixel looks along the edge between two triangles.
    mesh.from_pydata([(-half, 0, -half - 1), (-half, 0, half), (half + 3, 0, half), (half + 3, 0, -half - 1)], [],
                     [(0, 1, 2, 3)])
    mesh.materials.append(made)
    added(mesh)


def sphere(made, center, radius):
    # A point of Geometry Nodes, which is a true sphere and not a mesh.
    mesh = bpy.data.meshes.new('point')
    mesh.from_pydata([(0, 0, 0)], [], [])
    mesh.materials.append(made)
    thing = added(mesh, center)
    group = bpy.data.node_groups.new('points', 'GeometryNodeTree')
    group.inputs.new('NodeSocketGeometry', 'Geometry')
    group.outputs.new('NodeSocketGeometry', 'Geometry')
    nodes = [group.nodes.new(kind) for kind in ('NodeGroupInput', 'GeometryNodeMeshToPoints',
                                                'GeometryNodeSetMaterial', 'NodeGroupOutput')]
    nodes[1].inputs['Radius'].default_value = radius
    nodes[2].inputs['Material'].default_value = made
    for one, next_one in zip(nodes, nodes[1:]):
        group.links.new(one.outputs[0], next_one.inputs[0])
    thing.modifiers.new('points', 'NODES').node_group = group
    return thing


def moved(thing, by):
    # Cycles' times are even in [0, 254/256] only.
    scene = bpy.context.scene
    scene.render.use_motion_blur = True
    scene.render.motion_blur_shutter, scene.cycles.motion_blur_position = 1, 'START'
    scene.frame_start, scene.frame_end = 1, 2
    start = Vector(thing.location)
    for frame, part in ((1, 0), (2, 256 / 254)):
        thing.location = start + part * Vector(by)
        thing.keyframe_insert('location', frame=frame)
    for curve in thing.animation_data.action.fcurves:
        curve.extrapolation = 'LINEAR'
        for key in curve.keyframe_points:
            key.interpolation = 'LINEAR'
    scene.frame_set(1)


def square_lamp(center, side, radiance):  # shines down
    data = bpy.data.lights.new('lamp', 'AREA')
    data.energy, data.color, data.size = 4 * side * side, radiance, side
    thing = added(data, center)
    thing.rotation_mode = 'QUATERNION'
    thing.rotation_quaternion = Vector((0, -1, 0)).to_track_quat('-Z', 'Y')


def far_lamp(towards, color):  # directional light
    data = bpy.data.lights.new('lamp', 'SUN')
    data.energy, data.color, data.angle = math.pi, color, 0
    thing = added(data)
    thing.rotation_mode = 'QUATERNION'
    thing.rotation_quaternion = (-Vector(towards)).to_track_quat('-Z', 'Y')


def shadow():
    camera((0, 5.5, 6.5), (0, .4, 0), 40)
    background((0, 0, 0))
    floor(matte(.8, .7, .6))
    sphere(matte(.3, .5, .7), (-.9, 1.3, .2), .7)
    sphere(matte(.7, .7, .3), (1.2, .6, -.3), .5)
    square_lamp((0, 4, 0), 2, (6, 5, 4))


def lens():
    camera((0, 0, 6), (0, 0, 0), 30, lens=(.5, 6))
    background((0, 0, 0))
    sphere(shining(.9, .6, .3), (-.9, -.3, 0), .3)
    sphere(shining(.3, .9, .4), (.2, 1, -6), .3)
    sphere(shining(.8, .2, .7), (.5, -.2, 2.5), .06)


def motion():
    camera((0, 3, 6), (0, .4, 0), 34)
    background((0, 0, 0))  # it would light what is matte
    floor(matte(.7, .7, .7))
    moved(sphere(matte(.9, .4, .2), (-1, .6, 0), .5), (1.2, .3, -.4))
    sphere(matte(.2, .5, .8), (1.1, .5, -.6), .5)
    far_lamp((1, 2, 1.5), (.8, .7, .6))


def highlights():
    camera((0, 3, 6), (0, .5, 0), 36)
    background((0, 0, 0))
    floor(ggx(.5, 1, 1, 1))
    sphere(ggx(.25, 1, 1, 1), (-.8, .7, 0), .7)
    sphere(ggx(.6, 1, 1, 1), (.9, .6, .2), .6)
    square_lamp((0, 4, 0), 1.6, (6, 5, 4))


def mirror():
    camera((0, 2.2, 5), (0, 0, 0), 38)
    background((.1, .15, .25))
    floor(ggx(.15, .9, .8, .7))
    sphere(shining(2, 1.2, .5), (-.9, .9, -.6), .5)
    sphere(shining(.4, 1, 2), (.8, .6, .2), .4)


def picture(path):
    bpy.context.scene.render.filepath = path
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(path, check_existing=False)
    image.colorspace_settings.name = 'Non-Color'
    values = array.array('f', bytes(16 * width * height))
    image.pixels.foreach_get(values)
    bpy.data.images.remove(image)
    del values[3::4]
    return values  # from the lowest row up, as in a PFM


def write_pfm(path, values):
    with open(path, 'wb') as out:
        out.write(b'PF\n%d %d\n-1.0\n' % (width, height) + array.array('f', values).tobytes())


def main(folder):
    for draw in (shadow, lens, motion, highlights, mirror):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        settings(bpy.context.scene)
        draw()
        with tempfile.TemporaryDirectory() as place:
            pictures = []
            for seed in seeds:
                bpy.context.scene.cycles.seed = seed
                pictures.append(picture(os.path.join(place, 'seen.exr')))
        n = len(pictures)
        means = [math.fsum(all_of) / n for all_of in zip(*pictures)]
        errors = [math.sqrt(math.fsum((x - mean) ** 2 for x in all_of) / n / (n - 1))
                  for mean, all_of in zip(means, zip(*pictures))]
        write_pfm(os.path.join(folder, draw.__name__ + '.pfm'), means)
        write_pfm(os.path.join(folder, draw.__name__ + '.error.pfm'), errors)


main(sys.argv[sys.argv.index('--') + 1])
