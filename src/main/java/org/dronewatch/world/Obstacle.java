package org.dronewatch.world;

/**
 * The first thing that stands in a line of sight.
 *
 * @param model to which it belongs
 * @param material name of its material; empty where the mesh names none
 */
public record Obstacle(SiteModel model, String material) {}
