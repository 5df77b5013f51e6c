package org.dronewatch.render.canvas;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Outline;

/**
 * A sensor as drawn in a view.
 *
 * @param id name of the sensor
 * @param kind kind of the sensor
 * @param position position of the sensor, m
 * @param outline field of view of the sensor; empty if it has none
 * @param detecting whether the sensor detects a drone now
 */
public record SensorMark(String id, String kind, Position position, Optional<Outline> outline, boolean detecting) {}
