"""Prints the passes that Blender's compositor has of EXR files, a line for each layer:
blender -b --python blender_passes.py -- FILE[:LAYER] ...
"""

import sys

import bpy

scene = bpy.context.scene
scene.use_nodes = True
for argument in sys.argv[sys.argv.index("--") + 1 :]:
    file, _, layer = argument.partition(":")
    node = scene.node_tree.nodes.new("CompositorNodeImage")
    node.image = bpy.data.images.load(file)
    if layer:
        node.layer = layer
    passes = sorted(f"{output.name}/{output.type}" for output in node.outputs)
    print("PASSES", layer or "-", *passes)
