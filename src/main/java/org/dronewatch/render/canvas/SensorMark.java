package org.dronewatch.render.canvas;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Outline;

/**
 * A sensor as drawn in a view.
 *
 * @param id its name
 * @param kind its kind
 * @param position its position, m
 * @param outline its field of view
 * @param detecting whether it detects a drone now
 */
public record SensorMark(String id, String kind, Position position, Optional<Outline> outline, boolean detecting) {}
