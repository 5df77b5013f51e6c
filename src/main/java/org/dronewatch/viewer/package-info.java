/**
 * The window: a run is recorded while it is simulated, and the display shows one time of the recording. The simulation
 * knows nothing of it. Swing's event thread only paints and reacts; images are rendered on separate threads.
 */
package org.dronewatch.viewer;
