/** One run: the stage on which drones fly and sensors look, frames and their observers, detections, alerts, results. */
package org.dronewatch.run;
