/** Files that are read: bounded in size and heap, known by their hash and kind, whatever their format. */
package org.dronewatch.setting.input;
