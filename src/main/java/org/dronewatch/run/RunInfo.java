package org.dronewatch.run;

import org.dronewatch.scenario.SceneSettings;

/**
 * Which run begins.
 *
 * @param run its number in the sweep, from 0
 * @param runs how many runs there are
 * @param settings what it runs with
 */
public record RunInfo(int run, int runs, SceneSettings settings) {}
