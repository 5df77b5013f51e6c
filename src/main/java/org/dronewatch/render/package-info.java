/**
 * Pictures of a scene without a window: the site in 3D by the project's own ray tracer, with sensors, drones and rays
 * of sound in it. Used by the command line, by reports and by the viewer.
 */
package org.dronewatch.render;
