package org.dronewatch.sensor.alarm;

/**
 * Settings of a sensor whose false alarms are noise above its threshold: their rate follows from the probability of a
 * false alarm in each cell of its field of view. This is a capability, queried by
 * {@link org.dronewatch.sensor.SensorSettings#as}.
 */
public interface NoiseAlarming extends FalseAlarming {
    /**
     * The false-alarm probability per cell and look that yields a given rate.
     *
     * @param perHour desired number of false alarms per hour, above 0
     * @throws IllegalArgumentException when the number of cells is not known
     */
    double falseAlarmProbability(double perHour);

    /** The setting of the sensor that states its false-alarm probability, such as {@code falseAlarms.probability}. */
    String falseAlarmSetting();
}
