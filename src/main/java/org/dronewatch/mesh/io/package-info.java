/** Readers of model files: the settings of models, and a reader for each format. */
package org.dronewatch.mesh.io;
