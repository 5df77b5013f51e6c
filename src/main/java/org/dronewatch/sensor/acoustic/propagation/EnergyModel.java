package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.setting.Check;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Quantity;

/**
 * How the energy model propagates sound: the drone's sound power, in octave bands, is spread over rays that lose energy
 * to the air and at surfaces, so that levels fall by spreading as real ones do. The direct path and single mirror
 * reflections are exact; the rest is estimated from rays through a ball about the sensor, with its standard error.
 *
 * @param rays how many rays leave the drone, 1 to 10,000,000
 * @param roulette a ray with less than this share of its first energy goes on by chance only, above 0 and below 1
 * @param maxOrder how many surfaces a ray may meet before what is left of it is given up, 0 to 10,000
 */
public record EnergyModel(
        @In(Quantity.NUMBER) int rays, @In(Quantity.NUMBER) double roulette, @In(Quantity.NUMBER) int maxOrder)
        implements Propagation {

    /**
     * 8,000 rays, chance below one half, 1,000 orders: less than 0.5 dB of standard error in a church, for what a second
     * of tracing costs there. Late chance is cheap for levels; for reverberation times a thousandth is better.
     */
    public static final EnergyModel DEFAULT = new EnergyModel(8_000, 0.5, 1000);

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException when one does not hold
     */
    public EnergyModel {
        Check.between("rays", rays, 1, 10_000_000, Quantity.NUMBER);
        Check.inside("roulette", roulette, 0.0, 1.0, Quantity.NUMBER);
        Check.between("maxOrder", maxOrder, 0, 10_000, Quantity.NUMBER);
    }

    /** This model with another number of rays. */
    public EnergyModel withRays(int number) {
        return new EnergyModel(number, roulette, maxOrder);
    }

    /** This model with another share of energy below which rays go on by chance only. */
    public EnergyModel withRoulette(double share) {
        return new EnergyModel(rays, share, maxOrder);
    }
}
