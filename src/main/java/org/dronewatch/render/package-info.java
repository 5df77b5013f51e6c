/**
 * Pictures of a scene, drawn without a window: the site in 3D, with sensors, drones and rays of sound. The project's
 * ray tracer draws them. Used by the command line, by reports and by the viewer.
 */
package org.dronewatch.render;
