package org.dronewatch.run;

import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import org.dronewatch.scenario.SceneSettings;

/**
 * A run that is about to begin.
 *
 * @param run number of the run in the sweep, from 0
 * @param runs number of runs
 * @param settings the settings of the run
 */
public record RunInfo(int run, int runs, SceneSettings settings) {

    /**
     * The runs of a scene, or a single one of them.
     *
     * @param all the settings of all runs, in order
     * @param only index of the single run, from 0; empty for all runs
     * @throws IllegalArgumentException when there is no run with that index
     */
    public static List<RunInfo> of(List<SceneSettings> all, OptionalInt only) {
        if (only.isPresent() && (only.getAsInt() < 0 || only.getAsInt() >= all.size())) {
            throw new IllegalArgumentException("run " + only.getAsInt() + " must be 0 to " + (all.size() - 1));
        }
        return IntStream.range(0, all.size())
                .filter(run -> only.orElse(run) == run)
                .mapToObj(run -> new RunInfo(run, all.size(), all.get(run)))
                .toList();
    }
}
