/** A run of a scene: its world, drones and sensors, its frames and their listeners, detections, alerts and results. */
package org.dronewatch.run;
