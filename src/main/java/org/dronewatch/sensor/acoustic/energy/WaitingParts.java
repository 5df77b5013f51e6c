package org.dronewatch.sensor.acoustic.energy;

import java.util.stream.Stream;

/** The parts of a ray that wait until another part has ended; the last one is the first to go on. For one thread. */
final class WaitingParts {
    /** A ray that meets a wall while so many parts wait is not divided. */
    private static final int MOST = 8;

    private final PartOfRay[] parts =
            Stream.generate(PartOfRay::new).limit(MOST).toArray(PartOfRay[]::new);

    private int count;

    void clear() {
        count = 0;
    }

    boolean isEmpty() {
        return count == 0;
    }

    boolean isFull() {
        return count == MOST;
    }

    /** A part that waits from now on, to be filled in. */
    PartOfRay next() {
        return parts[count++];
    }

    /** The part that began to wait last; it is valid until the next part waits. */
    PartOfRay last() {
        return parts[--count];
    }
}
