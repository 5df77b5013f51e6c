/** Sites that were prepared once, kept in files of the user's cache directory. */
package org.dronewatch.run.store;
