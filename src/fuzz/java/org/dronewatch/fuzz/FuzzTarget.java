package org.dronewatch.fuzz;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;

/** One part of the program that is fed with random input, and how it is judged. */
public interface FuzzTarget {

    /** The name by which it is chosen. */
    String name();

    /**
     * Makes an input. The same dice and number give the same case.
     *
     * @param number of the case in its run, from 0: rare kinds come in turn, so that a short run meets each
     */
    FuzzCase generate(Dice dice, long number);

    /**
     * Feeds a case to the program.
     *
     * @param directory holds the files of the case; results may go into it
     * @throws Failure when the program does not do what it should
     * @throws IOException when a file of the case cannot be read back
     */
    void judge(FuzzCase input, Path directory) throws IOException;

    /** The processor time that one case may take. */
    default Duration longest() {
        return Duration.ofSeconds(10);
    }
}
