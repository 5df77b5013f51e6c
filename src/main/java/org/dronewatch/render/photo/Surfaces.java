package org.dronewatch.render.photo;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.MaterialLookup;
import org.dronewatch.world.World;

/** What the triangles of a mesh reflect. Immutable. */
final class Surfaces {
    /** Colour of materials that state none: pale stone. */
    private static final int UNNAMED = 0xb9b4aa;

    private final TriangleMesh mesh;
    private final MaterialLookup materials;
    private final double[] reflectances;

    /**
     * The surfaces of a mesh.
     *
     * @param colours as they look in white light on a screen, by name of the material
     */
    Surfaces(TriangleMesh mesh, Map<String, Integer> colours) {
        this(mesh, (triangle, x, y) -> mesh.material(triangle), mesh.materialNames(), colours);
    }

    /**
     * The surfaces of a world.
     *
     * @param colours as they look in white light on a screen, by name of the material
     */
    Surfaces(World world, Map<String, Integer> colours) {
        this(world.mesh(), world::material, world.materialNames(), colours);
    }

    private Surfaces(TriangleMesh mesh, MaterialLookup materials, List<String> names, Map<String, Integer> colours) {
        this.mesh = mesh;
        this.materials = materials;
        this.reflectances = new double[names.size() * Daylight.CHANNELS];
        for (int material = 0; material < names.size(); material++) {
            int colour = colours.getOrDefault(names.get(material), UNNAMED);
            for (int i = 0; i < Daylight.CHANNELS; i++) {
                reflectances[material * Daylight.CHANNELS + i] = Exposure.decoded(colour >> 16 - 8 * i & 255);
            }
        }
    }

    /** The number of the material of a triangle at a point on it, m; for a mesh, the point does not matter. */
    int material(int triangle, double x, double y) {
        return materials.at(triangle, x, y);
    }

    /** Fraction of the light in a channel that a material reflects. */
    double reflectance(int material, int channel) {
        return reflectances[material * Daylight.CHANNELS + channel];
    }

    /**
     * What the mesh reflects as seen from above, in each channel: the mean over all triangles that face up, by their
     * areas on a plan, each with the material at its middle; empty if there are none.
     */
    Optional<double[]> fromAbove() {
        double[] sum = new double[Daylight.CHANNELS];
        double[] normal = new double[3];
        double area = 0.0;
        for (int triangle = 0; triangle < mesh.triangleCount(); triangle++) {
            mesh.normal(triangle, normal);
            if (normal[2] > 0.0) {
                area += normal[2];
                int material = material(triangle, middle(triangle, 0), middle(triangle, 1));
                for (int i = 0; i < Daylight.CHANNELS; i++) {
                    sum[i] += normal[2] * reflectance(material, i);
                }
            }
        }
        double total = area;
        return total > 0.0
                ? Optional.of(Arrays.stream(sum).map(part -> part / total).toArray())
                : Optional.empty();
    }

    private double middle(int triangle, int axis) {
        return (mesh.coordinate(triangle, 0, axis)
                        + mesh.coordinate(triangle, 1, axis)
                        + mesh.coordinate(triangle, 2, axis))
                / 3.0;
    }

    /** Writes a normal of a triangle in the mesh's own space, of any length. */
    void normal(int triangle, double[] target) {
        mesh.normal(triangle, target);
    }
}
