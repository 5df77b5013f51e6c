/** The scenes of the library: each a short example of how to write another. */
package org.dronewatch.scenes;
