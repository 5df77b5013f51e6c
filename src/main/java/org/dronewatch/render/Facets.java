package org.dronewatch.render;

import java.util.List;
import java.util.Map;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.MaterialLookup;
import org.dronewatch.world.World;

/** The appearance of a mesh's triangles: their unit normals and colours. Immutable. */
final class Facets {
    /** Colour of materials that state none: pale stone. */
    private static final int UNNAMED = 0xb9b4aa;

    /** Screens show the dull colours of materials darker than daylight does. */
    private static final double BRIGHTER = 1.0 / 1.35;

    private final float[] normals;
    private final int[] colourOfMaterial;
    private final MaterialLookup materials;

    /** Facets of a mesh, with the colours of its materials by name. */
    Facets(TriangleMesh mesh, Map<String, Integer> colours) {
        this(mesh, (triangle, x, y) -> mesh.material(triangle), mesh.materialNames(), colours);
    }

    /** Facets of a world, with the colours of its materials by name. */
    Facets(World world, Map<String, Integer> colours) {
        this(world.mesh(), world::material, world.materialNames(), colours);
    }

    private Facets(TriangleMesh mesh, MaterialLookup materials, List<String> names, Map<String, Integer> colours) {
        this.materials = materials;
        this.normals = new float[3 * mesh.triangleCount()];
        double[] scratch = new double[3];
        for (int i = 0; i < mesh.triangleCount(); i++) {
            setNormal(mesh, i, scratch);
        }
        this.colourOfMaterial = names.stream()
                .mapToInt(name -> brighter(colours.getOrDefault(name, UNNAMED)))
                .toArray();
    }

    private static int brighter(int colour) {
        int rgb = 0;
        for (int shift = 16; shift >= 0; shift -= 8) {
            double share = (colour >> shift & 255) / 255.0;
            rgb |= (int) Math.round(255.0 * Math.pow(share, BRIGHTER)) << shift;
        }
        return rgb;
    }

    private void setNormal(TriangleMesh mesh, int triangle, double[] n) {
        mesh.normal(triangle, n);
        double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        double scale = 1.0 / Math.max(Double.MIN_NORMAL, length);
        for (int axis = 0; axis < 3; axis++) {
            normals[3 * triangle + axis] = (float) (n[axis] * scale);
        }
    }

    /** One coordinate of a triangle's unit normal, to the side from which its corners run counter-clockwise. */
    double normal(int triangle, int axis) {
        return normals[3 * triangle + axis];
    }

    /** The cosine of the angle between two triangles' normals. */
    double cosine(int one, int other) {
        return normal(one, 0) * normal(other, 0)
                + normal(one, 1) * normal(other, 1)
                + normal(one, 2) * normal(other, 2);
    }

    /** A triangle's colour in full light at a point on it, m. */
    int colour(int triangle, double x, double y) {
        return colourOfMaterial[materials.at(triangle, x, y)];
    }
}
