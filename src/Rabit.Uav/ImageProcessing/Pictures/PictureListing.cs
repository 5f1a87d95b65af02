using System;
using System.Collections.Generic;
using System.IO;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Finds the pictures of a folder that were not there before. What is no longer there is forgotten, so that its memory
/// is that of the names in the folder, however long it is watched. One thread.
/// </summary>
internal sealed class PictureListing
{
    // A file may appear within the same tick of the file system's clock as the last listing; so the folder is listed
    // now and then in any case.
    private const int ChecksPerListing = 10;

    private readonly string _folder;
    private readonly HashSet<string> _described = new(StringComparer.Ordinal);
    private HashSet<string> _seen = new(StringComparer.Ordinal);
    private HashSet<string> _present = new(StringComparer.Ordinal);
    private DateTime _changed;
    private int _looks;

    public PictureListing(CameraFolder folder)
    {
        _folder = folder.Path;
        foreach (ListedPicture picture in folder.Listed)
            _described.Add(picture.File);
    }

    /// <summary>How many names are remembered.</summary>
    public int Remembered => _seen.Count;

    /// <summary>Adds what is new, in no order.</summary>
    /// <param name="pictures">Takes pictures whose names have number and times.</param>
    /// <param name="nameless">Takes names of pictures that do not.</param>
    /// <exception cref="PictureException">The folder cannot be read, or is gone.</exception>
    public void FindNew(List<ListedPicture> pictures, List<string> nameless)
    {
        try
        {
            DateTime changed = Directory.GetLastWriteTimeUtc(_folder);
            bool isDue = _looks++ % ChecksPerListing == 0;
            if (changed == _changed && !isDue)
                return;
            _changed = changed;
            _present.Clear();
            foreach (string path in Directory.EnumerateFiles(_folder))
            {
                string name = Path.GetFileName(path);
                _present.Add(name);
                if (_seen.Contains(name) || _described.Contains(name))
                    continue;
                if (PictureFileName.TryParse(name, out PictureFileName facts))
                    pictures.Add(new ListedPicture(name, facts));
                else if (PictureFileName.IsPicture(name))
                    nameless.Add(name);
            }

            (_seen, _present) = (_present, _seen);
        }
        catch (Exception e) when (FileFaults.IsFileFault(e))
        {
            // It may have ended midway: what was found is known, and what it did not come to is not forgotten.
            _seen.UnionWith(_present);
            _changed = default;
            throw new PictureException(
                _folder, e is DirectoryNotFoundException ? "the folder is gone" : "it cannot be read: " + e.Message, e);
        }
    }
}
