package org.dronewatch.scene;

/**
 * Where the time of a scene's runs went, in seconds of a clock on the wall.
 *
 * @param load reading models
 * @param build building trees
 * @param wall simulating, after loading and building
 */
public record Timing(double load, double build, double wall) {}
