/** The scenes that come with the library: each a short example of how to write one's own. */
package org.dronewatch.scenes;
