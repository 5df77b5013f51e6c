/** The pictures and films of the command render. */
package org.dronewatch.app.rendering;
