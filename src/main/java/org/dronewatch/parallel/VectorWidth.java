package org.dronewatch.parallel;

import jdk.incubator.vector.FloatVector;

/**
 * How wide the processor's vectors are. A separate class, since it can only be loaded where the vector module is
 * present.
 */
final class VectorWidth {
    private VectorWidth() {}

    static int bits() {
        return FloatVector.SPECIES_PREFERRED.vectorBitSize();
    }
}
