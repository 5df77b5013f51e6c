package org.dronewatch.run;

import org.dronewatch.scenario.SceneSettings;

/**
 * A run that is about to begin.
 *
 * @param run its number in the sweep, from 0
 * @param runs how many runs there are
 * @param settings the settings of the run
 */
public record RunInfo(int run, int runs, SceneSettings settings) {}
