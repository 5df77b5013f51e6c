package org.dronewatch.scenario;

import java.util.function.ToDoubleFunction;

/**
 * What a plot of a sweep has on its horizontal axis.
 *
 * @param label quantity with its unit, as in {@code drone over background [dB]}
 * @param value its value in one run
 */
public record SweepAxis(String label, ToDoubleFunction<SceneSettings> value) {}
