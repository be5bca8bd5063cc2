/^    world.patterns.resize(world.needs.patterns/i\
    for (Material\& m : world.materials) m.ambient *= m.brightness, m.emission *= m.brightness;
