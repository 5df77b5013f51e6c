package org.dronewatch.render.photo;

import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.geometry.TriangleMesh;

/** What the triangles of a mesh reflect. Immutable. */
final class Surfaces {
    /** Colour of materials that state none: pale stone. */
    private static final int UNNAMED = 0xb9b4aa;

    private final TriangleMesh mesh;
    private final double[] reflectances;

    /** @param colours as they look in white light on a screen, by name of the material */
    Surfaces(TriangleMesh mesh, Map<String, Integer> colours) {
        this.mesh = mesh;
        this.reflectances = new double[mesh.materialNames().size() * Daylight.CHANNELS];
        for (int material = 0; material < mesh.materialNames().size(); material++) {
            int colour = colours.getOrDefault(mesh.materialNames().get(material), UNNAMED);
            for (int i = 0; i < Daylight.CHANNELS; i++) {
                reflectances[material * Daylight.CHANNELS + i] = Exposure.decoded(colour >> 16 - 8 * i & 255);
            }
        }
    }

    /** Fraction of the light in a channel that a triangle reflects. */
    double reflectance(int triangle, int channel) {
        return reflectances[mesh.material(triangle) * Daylight.CHANNELS + channel];
    }

    /**
     * What the mesh reflects as seen from above, in each channel: the mean over all triangles that face up, by their
     * areas on a plan; empty if there are none.
     */
    Optional<double[]> fromAbove() {
        double[] sum = new double[Daylight.CHANNELS];
        double[] normal = new double[3];
        double area = 0.0;
        for (int triangle = 0; triangle < mesh.triangleCount(); triangle++) {
            mesh.normal(triangle, normal);
            if (normal[2] > 0.0) {
                area += normal[2];
                for (int i = 0; i < Daylight.CHANNELS; i++) {
                    sum[i] += normal[2] * reflectance(triangle, i);
                }
            }
        }
        double total = area;
        return total > 0.0
                ? Optional.of(Arrays.stream(sum).map(part -> part / total).toArray())
                : Optional.empty();
    }

    /** Writes a normal of a triangle in the mesh's own space, of any length. */
    void normal(int triangle, double[] target) {
        mesh.normal(triangle, target);
    }
}
