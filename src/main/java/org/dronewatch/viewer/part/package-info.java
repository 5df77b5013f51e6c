/**
 * Parts of a window that do not depend on what the window shows: sizes, texts, menu items and work in the background.
 */
package org.dronewatch.viewer.part;
