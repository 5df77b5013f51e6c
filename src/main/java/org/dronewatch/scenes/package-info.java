/** The scenes of the library, each of which is also a short example of how to write a scene. */
package org.dronewatch.scenes;
