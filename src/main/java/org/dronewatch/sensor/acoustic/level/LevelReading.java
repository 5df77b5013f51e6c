package org.dronewatch.sensor.acoustic.level;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalInt;

/**
 * The result of one look of an acoustic sensor at one drone, in the level model.
 *
 * @param bestLevel the highest level received along any ray, dB on the calibrated scale of the level model; minus
 *     infinity when nothing was received
 * @param detected whether the best level reaches the threshold
 * @param energy the received fraction of the emitted energy, summed over all rays: for information only, since rays
 *     that are aimed at the sensor make it unphysical
 * @param received number of rays that reached the sensor
 * @param traced number of ray segments that were traced
 * @param cutByOrder number of rays not followed because of the maximum order
 * @param cutByBudget number of rays not followed because of the ray budget
 * @param cutOrder the lowest order of a ray that the budget ended; empty if it ended none
 */
public record LevelReading(
        double bestLevel,
        boolean detected,
        double energy,
        long received,
        long traced,
        long cutByOrder,
        long cutByBudget,
        OptionalInt cutOrder) {

    /** The figures for reports, by names that include their units. */
    public Map<String, Double> figures() {
        Map<String, Double> figures = new LinkedHashMap<>();
        figures.put("rays_traced", (double) traced);
        figures.put("rays_received", (double) received);
        figures.put("cut_by_order", (double) cutByOrder);
        figures.put("cut_by_budget", (double) cutByBudget);
        cutOrder.ifPresent(order -> figures.put("cut_at_order", (double) order));
        return figures;
    }
}
