/** Parts of a window that know nothing of what it shows: sizes, texts, menu items and work in the background. */
package org.dronewatch.viewer.part;
