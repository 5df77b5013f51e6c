package org.dronewatch.fuzz;

import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;

/** Derives the seed of a case from that of the run, so that a single case can be made again. */
final class Seeds {

    private Seeds() {}

    /** The seed of one case. */
    static long of(long seed, String target, long number) {
        CRC32 name = new CRC32();
        name.update(target.getBytes(StandardCharsets.UTF_8));
        return mix(mix(mix(seed) ^ name.getValue()) + number);
    }

    /** Stafford's variant 13 of the finaliser of MurmurHash3. */
    private static long mix(long value) {
        long mixed = value + 0x9E3779B97F4A7C15L;
        mixed = (mixed ^ mixed >>> 30) * 0xBF58476D1CE4E5B9L;
        mixed = (mixed ^ mixed >>> 27) * 0x94D049BB133111EBL;
        return mixed ^ mixed >>> 31;
    }
}
