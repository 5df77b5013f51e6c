package org.dronewatch.world;

/**
 * The first surface that blocks a line of sight.
 *
 * @param model the model to which it belongs
 * @param material name of its material; empty if the mesh names none
 */
public record Obstacle(SiteModel model, String material) {}
