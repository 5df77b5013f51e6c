/**
 * The window: a run is recorded while it is simulated, and what is shown is a time of the recording. The simulation knows
 * nothing of it. Swing's event thread only paints and reacts; pictures are made on threads of their own.
 */
package org.dronewatch.viewer;
