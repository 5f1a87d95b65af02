using Rabit.Core;
using Rabit.Uav.ImageProcessing;

namespace Rabit.Uav.Simulation;

/// <summary>Writes pictures to a folder, and gives their buffers back. Runs on the writer's thread.</summary>
internal sealed class PictureFolderTarget(PictureFolderWriter writer) : IWriterTarget<RecordedPicture>
{
    public bool Blocks => false;

    public void Open()
    {
    }

    public void Write(in RecordedPicture value)
    {
        try
        {
            writer.Write(value.Frame, value.FrameStartUtc);
        }
        finally
        {
            value.Dispose();
        }
    }

    public void Unblock()
    {
    }

    public void Close()
    {
    }
}
