package org.dronewatch.world;

/**
 * The first surface that blocks a line of sight.
 *
 * @param model that it belongs to
 * @param material name of its material; empty if the mesh names none
 */
public record Obstacle(SiteModel model, String material) {}
