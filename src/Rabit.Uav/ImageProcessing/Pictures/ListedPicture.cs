namespace Rabit.Uav.ImageProcessing;

/// <summary>A picture of a camera's folder: its file, and what its name or camera.json says of it.</summary>
internal sealed class ListedPicture(string file, PictureFileName facts)
{
    /// <summary>Within the folder.</summary>
    public string File { get; } = file;

    public PictureFileName Facts { get; } = facts;
}
