/** The pictures and films of the {@code render} command. */
package org.dronewatch.app.rendering;
