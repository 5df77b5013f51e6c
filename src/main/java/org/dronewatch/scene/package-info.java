/**
 * A scene: one tree of settings, described by a user's {@code build()}, from which a world, drones and sensors are
 * created and run as a DSOL model. Only this package depends on DSOL.
 */
package org.dronewatch.scene;
