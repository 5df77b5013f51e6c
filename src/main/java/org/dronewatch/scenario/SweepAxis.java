package org.dronewatch.scenario;

import java.util.function.ToDoubleFunction;

/**
 * The horizontal axis of a plot of a sweep.
 *
 * @param label quantity with its unit, as in {@code drone over background [dB]}
 * @param value value of the quantity in one run
 */
public record SweepAxis(String label, ToDoubleFunction<SceneSettings> value) {}
