package org.dronewatch.sensor.acoustic.imagesource;

import java.util.Arrays;

/**
 * The solids that a path of sound is inside, by the indices of their materials. The solids may overlap, as walls do at
 * the corners of merged models: a path that leaves one of them may still be inside the others. A mutable, reused
 * object, for use by one thread.
 */
public final class EnteredSolids {
    /** No solids: the path is in the air. Not to be modified. */
    public static final EnteredSolids NONE = new EnteredSolids();

    private int[] materials = new int[4];

    /** The number of faces through which each solid was entered: several faces that coincide belong to one solid. */
    private int[] faces = new int[4];

    private int count;

    /** Leaves all solids. */
    public void clear() {
        count = 0;
    }

    /** Takes over the solids of another path. */
    public void copy(EnteredSolids other) {
        if (other.count == 0) {
            // Most paths begin in the air.
            count = 0;
            return;
        }
        if (materials.length < other.count) {
            materials = new int[other.materials.length];
            faces = new int[other.faces.length];
        }
        System.arraycopy(other.materials, 0, materials, 0, other.count);
        System.arraycopy(other.faces, 0, faces, 0, other.count);
        count = other.count;
    }

    /**
     * Enters a solid.
     *
     * @param through number of its faces that coincide at the point of entry, 1 or more
     */
    void enter(int material, int through) {
        if (count == materials.length) {
            materials = Arrays.copyOf(materials, 2 * count);
            faces = Arrays.copyOf(faces, 2 * count);
        }
        materials[count] = material;
        faces[count++] = through;
    }

    /** The number of faces through which the last solid of a material was entered; 0 outside of all of them. */
    int faces(int material) {
        for (int i = count - 1; i >= 0; i--) {
            if (materials[i] == material) {
                return faces[i];
            }
        }
        return 0;
    }

    /**
     * Leaves the solid of a material if the path is within one.
     *
     * @return whether the path was within one
     */
    boolean leave(int material) {
        for (int i = count - 1; i >= 0; i--) {
            if (materials[i] == material) {
                count--;
                System.arraycopy(materials, i + 1, materials, i, count - i);
                System.arraycopy(faces, i + 1, faces, i, count - i);
                return true;
            }
        }
        return false;
    }
}
