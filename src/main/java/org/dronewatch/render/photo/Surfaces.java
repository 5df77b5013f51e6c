package org.dronewatch.render.photo;

import java.util.Map;
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

    /** Writes a normal of a triangle in the mesh's own space, of any length. */
    void normal(int triangle, double[] target) {
        mesh.normal(triangle, target);
    }
}
