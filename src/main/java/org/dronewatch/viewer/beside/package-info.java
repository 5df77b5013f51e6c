/** What differs between the run that a window shows and another run: the <em>Compare</em> tab. */
package org.dronewatch.viewer.beside;
