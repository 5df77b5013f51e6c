/** Models read from files: their settings, and a reader for each format. */
package org.dronewatch.mesh.io;
