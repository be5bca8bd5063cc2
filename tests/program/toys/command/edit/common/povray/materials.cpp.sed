s/m\.ambient + m\.emission/m.brightness * (m.ambient + m.emission)/
