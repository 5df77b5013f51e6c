package org.dronewatch.parallel;

import jdk.incubator.vector.FloatVector;

/**
 * The width of the processor's vectors. A separate class, since it can only be loaded where the vector module is
 * present.
 */
final class VectorWidth {
    private VectorWidth() {}

    static int bits() {
        return FloatVector.SPECIES_PREFERRED.vectorBitSize();
    }
}
