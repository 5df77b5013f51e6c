package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;

/**
 * The solids within which a path of sound is, by the numbers of their materials. They may overlap, as walls do at the
 * corners of merged models: leaving one of them does not end the others. A mutable, reused object, for one thread.
 */
final class EnteredSolids {
    /** Air: within no solid. Not to be modified. */
    static final EnteredSolids NONE = new EnteredSolids();

    private int[] materials = new int[4];
    private int count;

    /** Back into air. */
    void clear() {
        count = 0;
    }

    /** Takes over the solids of another path. */
    void copy(EnteredSolids other) {
        if (materials.length < other.count) {
            materials = new int[other.materials.length];
        }
        System.arraycopy(other.materials, 0, materials, 0, other.count);
        count = other.count;
    }

    /** Enters a solid of a material. */
    void enter(int material) {
        if (count == materials.length) {
            materials = Arrays.copyOf(materials, 2 * count);
        }
        materials[count++] = material;
    }

    /**
     * Leaves the solid of a material if the path is within one.
     *
     * @return whether it was
     */
    boolean leave(int material) {
        for (int i = count - 1; i >= 0; i--) {
            if (materials[i] == material) {
                count--;
                System.arraycopy(materials, i + 1, materials, i, count - i);
                return true;
            }
        }
        return false;
    }
}
