/**
 * The canvas of a picture, with a depth buffer, and what is drawn on it with lines: marks of drones and sensors,
 * outlines and flights.
 */
package org.dronewatch.render.canvas;
