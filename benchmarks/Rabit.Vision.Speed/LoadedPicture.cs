using Rabit.Uav.ImageProcessing;

namespace Rabit.Vision.Speed;

/// <summary>A picture in colour and in grey, with what a pixel of it covers on the ground.</summary>
internal sealed record LoadedPicture(byte[] Pixels, byte[] Grey, int Width, int Height, PictureGroundScale Scale);
