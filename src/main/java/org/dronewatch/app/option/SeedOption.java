package org.dronewatch.app.option;

import java.util.Optional;
import org.dronewatch.scene.SceneRunner;
import picocli.CommandLine.Option;

/** The option of commands that run a scene with another seed. */
public final class SeedOption {
    @Option(names = "--seed", paramLabel = "N", description = "Seed of all random numbers.")
    private Long seed;

    /** The seed; empty if none was given. */
    public Optional<Long> number() {
        return Optional.ofNullable(seed);
    }

    /** Sets the seed of a runner if one was given. */
    public void apply(SceneRunner runner) {
        if (seed != null) {
            runner.seed(seed);
        }
    }
}
