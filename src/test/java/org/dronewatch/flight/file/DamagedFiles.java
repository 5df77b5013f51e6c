package org.dronewatch.flight.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.Function;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.setting.InputException;

/** Files with bytes that are missing or wrong: whatever they hold, they are read or refused in a line. */
public final class DamagedFiles {
    private static final int SEEDS = 600;

    private DamagedFiles() {}

    /** How many of 600 files, damaged with seeds 0 to 599, are refused. */
    public static int refused(String whole, Function<byte[], FlightPath> reader) {
        byte[] bytes = whole.getBytes(StandardCharsets.UTF_8);
        int refused = 0;
        for (int seed = 0; seed < SEEDS; seed++) {
            refused += isRefused(seed, damaged(bytes, new SplittableRandom(seed)), reader) ? 1 : 0;
        }
        return refused;
    }

    private static byte[] damaged(byte[] whole, SplittableRandom random) {
        byte[] bytes = whole.clone();
        if (random.nextInt(4) == 0) {
            return Arrays.copyOf(bytes, random.nextInt(bytes.length));
        }
        for (int i = random.nextInt(1, 4); i > 0; i--) {
            int at = random.nextInt(bytes.length);
            bytes[at] = random.nextBoolean()
                    ? (byte) (bytes[at] ^ 1 << random.nextInt(8))
                    : (byte) "0123456789-.e<>{}[],\"".charAt(random.nextInt(20));
        }
        return bytes;
    }

    private static boolean isRefused(int seed, byte[] bytes, Function<byte[], FlightPath> reader) {
        try {
            reader.apply(bytes).at(17.0);
            return false;
        } catch (InputException | IllegalArgumentException e) {
            assertThat(e.getMessage().lines()).as("seed %s", seed).hasSize(1);
            return true;
        } catch (RuntimeException | StackOverflowError e) {
            throw new AssertionError("seed " + seed, e);
        }
    }
}
