/**
 * The viewer window: a run is recorded while it is simulated, and the display shows one time of the recording. The
 * simulation does not depend on the viewer. Swing's event thread only paints and handles events; images are rendered on
 * separate threads.
 */
package org.dronewatch.viewer;
