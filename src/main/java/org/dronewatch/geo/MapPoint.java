package org.dronewatch.geo;

/**
 * A point in the coordinates of a {@link CoordinateReferenceSystem}.
 *
 * @param x eastward coordinate, in the system's unit: metres for most grids, or degrees of longitude
 * @param y northward coordinate, in the system's unit: metres for most grids, or degrees of latitude
 * @param height height above the ellipsoid, or above the datum of a file's heights, m
 */
public record MapPoint(double x, double y, double height) {}
