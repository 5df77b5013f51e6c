package org.dronewatch.parallel;

import jdk.incubator.vector.FloatVector;

/** How wide the processor's vectors are. Apart, since it can only be loaded where the module of vectors is. */
final class VectorWidth {
    private VectorWidth() {}

    static int bits() {
        return FloatVector.SPECIES_PREFERRED.vectorBitSize();
    }
}
