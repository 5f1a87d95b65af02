using System;
using System.IO;
using System.Text;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Vision;
using Rabit.Vision.Tests.Pictures;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

public sealed class CameraFolderTests : IDisposable
{
    private const string Known = """
        {"format":"uav-imagery-camera","version":2,"origin":{"lat_deg":39.0086},
         "camera":{"name":"cam640","width":640,"height":480,"fx":531.4,"fy":530.7,"cx":321.9,"cy":237.6,
          "distortion":[-0.214,0.069,0.0006,-0.0004,-0.008],
          "mount":{"bodyFromCamera":[[0.0,-1.0,0.0],[1.0,0.0,0.0],[0.0,0.0,1.0]],"leverArmBodyMetres":[0.12,-0.02,0.06]}},
         "frames":[{"file":"frames/b.png","frameStartMicroseconds":469185613,"exposureMicroseconds":1098},
                   {"file":"frames/a.png","frameStartMicroseconds":468985841,"exposureMicroseconds":1095}]}
        """;

    private const string Fixed = "\"bodyFromCamera\":[[0.0,-1.0,0.0],[1.0,0.0,0.0],[0.0,0.0,1.0]]";

    private readonly SamplePictures.TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Open_KnownDescription_GivesItsNumbers()
    {
        CameraFolder folder = Open(Known);

        Assert.Equal(
            (640, 480, 531.4, 530.7),
            (folder.Camera.Width, folder.Camera.Height, folder.Camera.FocalX, folder.Camera.FocalY));
        Assert.Equal((321.9, 237.6), (folder.Camera.CentreX, folder.Camera.CentreY));
        Assert.Equal(
            (-0.214, 0.069, 0.0006, -0.0004, -0.008),
            (folder.Camera.K1, folder.Camera.K2, folder.Camera.P1, folder.Camera.P2, folder.Camera.K3));
        CameraExtrinsics placement = folder.Mount.At(Angle.Zero, Angle.Zero);
        Assert.Equal(
            (0.12, -0.02, 0.06),
            (placement.PositionMetres.Forward, placement.PositionMetres.Right, placement.PositionMetres.Down));
        (double forward, double right, double down) = placement.BodyFromCamera.Apply(1, 2, 3);
        Assert.Equal(-2, forward, 9);
        Assert.Equal(1, right, 9);
        Assert.Equal(3, down, 9);
    }

    [Fact]
    public void Open_ListedFrames_AreInTheOrderOfTheirTimes()
    {
        CameraFolder folder = Open(Known);

        Assert.Equal(["frames/a.png", "frames/b.png"], [folder.Listed[0].File, folder.Listed[1].File]);
        Assert.Equal(
            (468985841, 1095),
            (folder.Listed[0].Facts.StartUtcMicroseconds, folder.Listed[0].Facts.ExposureMicroseconds));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(0.7)]
    public void Open_OfCreate_GivesTheSame(double gimbalYaw)
    {
        var camera = new CameraModel
        {
            Width = 64,
            Height = 48,
            FocalX = 53.1,
            FocalY = 52.9,
            CentreX = 31.25,
            CentreY = 23.5,
            K1 = -0.06,
            K2 = 0.01,
            P1 = 1e-4,
            P2 = -2e-4,
            K3 = 1e-3,
            Readout = TimeSpan.FromTicks(305)
        };
        var mount = new CameraMount
        {
            GimbalLeverArmMetres = new BodyVector(0.1, -0.2, 0.05),
            MisalignmentRoll = Angle.FromRadians(0.02),
            CameraLeverArmMetres = new BodyVector(0.01, 0, 0)
        };
        string path = Path.Combine(_folder.Path, "new", "camera");

        CameraFolder written = CameraFolder.Create(
            path, camera, mount, gimbalPitch: Angle.FromRadians(-1.2), gimbalYaw: Angle.FromRadians(gimbalYaw));
        CameraFolder read = CameraFolder.Open(path);

        CameraExtrinsics wanted = mount.At(Angle.FromRadians(-1.2), Angle.FromRadians(gimbalYaw));
        foreach (CameraFolder folder in new[] { written, read })
        {
            Assert.Equal((64, 48, 53.1, 52.9, 31.25, 23.5), (folder.Camera.Width, folder.Camera.Height,
                folder.Camera.FocalX, folder.Camera.FocalY, folder.Camera.CentreX, folder.Camera.CentreY));
            Assert.Equal(
                (-0.06, 0.01, 1e-4, -2e-4, 1e-3),
                (folder.Camera.K1, folder.Camera.K2, folder.Camera.P1, folder.Camera.P2, folder.Camera.K3));
            Assert.Equal(30.5, folder.Camera.Readout.TotalMilliseconds * 1000, 9);
            CameraExtrinsics placement = folder.Mount.At(Angle.Zero, Angle.Zero);
            Assert.Equal(0, (wanted.BodyFromCamera.Inverse * placement.BodyFromCamera).Angle.Radians, 9);
            Assert.Equal(wanted.PositionMetres.Forward, placement.PositionMetres.Forward, 12);
            Assert.Equal(wanted.PositionMetres.Right, placement.PositionMetres.Right, 12);
            Assert.Equal(wanted.PositionMetres.Down, placement.PositionMetres.Down, 12);
        }
    }

    [Fact]
    public void Create_DefaultMount_PointsDownWithTheTopForward()
    {
        CameraFolder folder = CameraFolder.Create(
            _folder.Path, new CameraModel { Width = 8, Height = 8, FocalX = 9, FocalY = 9 }, new CameraMount());

        Rotation rotation = folder.Mount.At(Angle.Zero, Angle.Zero).BodyFromCamera;
        Assert.Equal(0, (rotation.Inverse * Rotation.FromMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)).Angle.Radians, 9);
    }

    [Fact]
    public void Create_NoCamera_SaysAllThatIsWrong()
    {
        PictureException fault = Assert.Throws<PictureException>(() => CameraFolder.Create(
            _folder.Path, new CameraModel { Width = 0, Height = 8, FocalX = -1, FocalY = 9 },
            new CameraMount { MisalignmentRoll = Angle.NaN }));

        Assert.Contains("0 x 8", fault.Message, StringComparison.Ordinal);
        Assert.Contains("focal length", fault.Message, StringComparison.Ordinal);
        Assert.Contains("misalignment", fault.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("[]", "camera is missing")]
    [InlineData("{}", "camera is missing")]
    [InlineData("{\"camera\":5}", "camera is missing or no object")]
    [InlineData("{\"camera\":{}}", "camera.width is missing; camera.height is missing; camera.fx is missing")]
    [InlineData("nonsense", "not JSON")]
    [InlineData("", "not JSON")]
    public void Open_WrongDescription_SaysWhy(string json, string reason)
    {
        PictureException fault = Assert.Throws<PictureException>(() => Open(json));

        Assert.Contains(CameraFolder.DescriptionFile, fault.Message, StringComparison.Ordinal);
        Assert.Contains(reason, fault.Message, StringComparison.Ordinal);
        Assert.DoesNotContain("\n", fault.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("\"width\":640", "\"width\":640.5", "camera.width is 640.5; it must be a whole number")]
    [InlineData("\"width\":640", "\"width\":70000", "70000 x 480")]
    [InlineData("\"fx\":531.4", "\"fx\":\"531.4\"", "camera.fx is \"531.4\"; it must be a number")]
    [InlineData("\"fx\":531.4", "\"fx\":0", "focal length")]
    [InlineData("-0.008]", "-0.008,1]", "list of 5 or 8 numbers")]
    [InlineData("[0.12,-0.02,0.06]", "[0.12,-0.02]", "list of 3 numbers")]
    [InlineData("[[0.0,-1.0,0.0],", "[[0.0,1.0,0.0],", "bodyFromCamera")]
    [InlineData("[[0.0,-1.0,0.0],", "[[0.0,-1.0],", "it must be a list of three lists of three numbers")]
    [InlineData("-0.214", "-4.0", "distortion")]
    [InlineData("frames/b.png", "../b.png", "frames[0] has no file")]
    [InlineData("frames/b.png", "/etc/b.png", "frames[0] has no file")]
    [InlineData("\"frameStartMicroseconds\":468985841", "\"start\":468985841", "frames[1] has no file")]
    public void Open_OneThingWrong_IsNamed(string right, string wrong, string reason)
    {
        Assert.Contains(right, Known, StringComparison.Ordinal);

        PictureException fault = Assert.Throws<PictureException>(() => Open(Known.Replace(right, wrong)));

        Assert.Contains(reason, fault.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("distortion", "dist_k1_k2_p1_p2_k3",
        "camera.dist_k1_k2_p1_p2_k3 is of an older form of the file; it is camera.distortion now")]
    [InlineData("bodyFromCamera", "R_body_from_cam",
        "camera.mount.R_body_from_cam is of an older form of the file; it is camera.mount.bodyFromCamera now")]
    [InlineData("leverArmBodyMetres", "lever_arm_body_m", "it is camera.mount.leverArmBodyMetres now")]
    [InlineData("frameStartMicroseconds", "frame_start_us", "it is frames[0].frameStartMicroseconds now")]
    [InlineData("\"height\"", "\"row_readout_us\":3,\"height\"", "it is camera.rowReadoutMicroseconds now")]
    public void Open_NameOfTheOldForm_IsRefusedWithTheNewOne(string now, string old, string reason)
    {
        PictureException fault = Assert.Throws<PictureException>(() => Open(Known.Replace(now, old)));

        Assert.Contains(reason, fault.Message, StringComparison.Ordinal);
        Assert.DoesNotContain("is missing", fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Open_NameThatIsWronglySpelt_IsRefusedWithTheRightOne()
        => Assert.Contains(
            "camera.rowReadoutMicrosecond is unknown; did you mean rowReadoutMicroseconds?",
            Assert.Throws<PictureException>(
                () => Open(Known.Replace("\"height\"", "\"rowReadoutMicrosecond\":3,\"height\""))).Message,
            StringComparison.Ordinal);

    [Theory]
    [InlineData("\"version\"", "\"verson\"", "verson is unknown; did you mean version?")]
    [InlineData("\"origin\"", "\"frame\"", "frame is unknown; did you mean frames?")]
    [InlineData("\"frameStartMicroseconds\":469185613", "\"frameStartMicros\":1,\"frameStartMicroseconds\":469185613",
        "frames[0].frameStartMicros is unknown; did you mean frameStartMicroseconds?")]
    [InlineData("\"exposureMicroseconds\":1095", "\"exposureMicrosecond\":1095",
        "frames[1].exposureMicrosecond is unknown; did you mean exposureMicroseconds?")]
    public void Open_UnknownNameOutsideTheCamera_IsRefusedByName(string right, string wrong, string reason)
    {
        Assert.Contains(right, Known, StringComparison.Ordinal);

        PictureException fault = Assert.Throws<PictureException>(() => Open(Known.Replace(right, wrong)));

        Assert.Contains(reason, fault.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("\"roll_deg\":1", "mount.roll_deg", "mount.gimbal.misalignmentRollDegrees")]
    [InlineData("\"pitch_deg\":1", "mount.pitch_deg", "mount.gimbal.misalignmentPitchDegrees")]
    [InlineData("\"yaw_deg\":1", "mount.yaw_deg", "mount.gimbal.misalignmentYawDegrees")]
    [InlineData("\"lever_arm_gimbal_m\":[0,0,0]", "mount.lever_arm_gimbal_m", "mount.gimbal.leverArmGimbalMetres")]
    [InlineData("\"gimbal\":{\"yaw_deg\":1}", "mount.gimbal.yaw_deg", "mount.gimbal.misalignmentYawDegrees")]
    public void Open_GimbalOfTheOldForm_IsRefusedWithTheNewName(string gimbal, string old, string now)
        => Assert.EndsWith(
            $"camera.{old} is of an older form of the file; it is camera.{now} now",
            Assert.Throws<PictureException>(() => Open(Known.Replace(Fixed, gimbal))).Message,
            StringComparison.Ordinal);

    [Fact]
    public void Open_MountOnAGimbal_GivesItsMisalignmentAndLeverArms()
    {
        CameraMount mount = Open(Known.Replace(
            Fixed,
            """
            "gimbal":{"misalignmentRollDegrees":1,"misalignmentPitchDegrees":-2,"misalignmentYawDegrees":3,"leverArmGimbalMetres":[0.01,0.02,0.03]}
            """)).Mount;

        Assert.Null(mount.FixedBodyFromCamera);
        Assert.Equal(
            (1, -2, 3),
            (mount.MisalignmentRoll.Degrees, mount.MisalignmentPitch.Degrees, mount.MisalignmentYaw.Degrees));
        Assert.Equal(
            (new BodyVector(0.12, -0.02, 0.06), new BodyVector(0.01, 0.02, 0.03)),
            (mount.GimbalLeverArmMetres, mount.CameraLeverArmMetres));
    }

    [Fact]
    public void Open_EmptyGimbal_HasNoMisalignment()
    {
        CameraMount mount = Open(Known.Replace(Fixed, "\"gimbal\":{}")).Mount;

        Assert.Equal(
            (null, Angle.Zero, Angle.Zero, Angle.Zero),
            (mount.FixedBodyFromCamera, mount.MisalignmentRoll, mount.MisalignmentPitch, mount.MisalignmentYaw));
        Assert.Equal(default, mount.CameraLeverArmMetres);
    }

    [Theory]
    [InlineData("\"gimbal\":{\"roll\":1}", "camera.mount.gimbal.roll is unknown")]
    [InlineData("\"gimbal\":3", "camera.mount.gimbal is 3; it must be an object")]
    [InlineData("\"gimbal\":{\"misalignmentYawDegrees\":\"1\"}",
        "camera.mount.gimbal.misalignmentYawDegrees is \"1\"; it must be a number")]
    [InlineData("\"gimbal\":{},\"bodyFromCamera\":[[1,0,0],[0,1,0],[0,0,1]]", "it must have one of them")]
    [InlineData("\"note\":0", "camera.mount.bodyFromCamera is missing")]
    public void Open_WrongGimbal_IsNamed(string gimbal, string reason)
        => Assert.Contains(
            reason, Assert.Throws<PictureException>(() => Open(Known.Replace(Fixed, gimbal))).Message,
            StringComparison.Ordinal);

    [Fact]
    public void OpenFile_OfAnotherName_ReadsItAndHasItsFolder()
    {
        File.WriteAllText(_folder.File("nadir.json"), Known);

        CameraFolder read = CameraFolder.OpenFile(_folder.File("nadir.json"));

        Assert.Equal((_folder.Path, 640), (read.Path, read.Camera.Width));
        Assert.Contains(
            "none.json: no such file",
            Assert.Throws<PictureException>(() => CameraFolder.OpenFile(_folder.File("none.json"))).Message,
            StringComparison.Ordinal);
        Assert.Throws<ArgumentNullException>(() => CameraFolder.OpenFile(null!));
    }

    [Fact]
    public void Open_MarkOfUtf8AtTheBeginning_IsRead()
    {
        File.WriteAllText(
            _folder.File(CameraFolder.DescriptionFile), Known, new UTF8Encoding(encoderShouldEmitUTF8Identifier: true));

        Assert.Equal(640, CameraFolder.Open(_folder.Path).Camera.Width);
    }

    [Fact]
    public void Open_NothingThere_SaysSo()
    {
        Assert.Contains(
            "no such folder", Assert.Throws<PictureException>(() => CameraFolder.Open(_folder.File("none"))).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "camera.json", Assert.Throws<PictureException>(() => CameraFolder.Open(_folder.Path)).Message,
            StringComparison.Ordinal);
    }

    // A file of an editor that writes Latin-1.
    [Theory]
    [InlineData("\"name\": \"K\u00fcste\"", "camera.name is a text that cannot be read: the file must be UTF-8")]
    [InlineData("\"n\u00e4me\": 1", "camera.(a name) is a text that cannot be read: the file must be UTF-8")]
    [InlineData("\"name\": [1, \"\\udc00\"]", "camera.name[1] is a text that cannot be read: the file must be UTF-8")]
    public void Open_TextThatIsNotUtf8_IsRefused(string field, string fault)
    {
        File.WriteAllBytes(
            _folder.File(CameraFolder.DescriptionFile),
            Encoding.GetEncoding("ISO-8859-1").GetBytes("{ \"camera\": { " + field + " } }"));

        Assert.Contains(
            fault, Assert.Throws<PictureException>(() => CameraFolder.Open(_folder.Path)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Open_File_IsTheDescriptionWhateverItsName()
    {
        File.WriteAllText(_folder.File("nadir.json"), Known);
        File.WriteAllText(_folder.File("photo"), "x");

        CameraFolder folder = CameraFolder.Open(_folder.File("nadir.json"));

        Assert.Equal((640, _folder.Path), (folder.Camera.Width, folder.Path));
        Assert.IsType<FolderCamera>(folder.CreateCamera());
        Assert.Contains(
            "it is not JSON", Assert.Throws<PictureException>(() => CameraFolder.Open(_folder.File("photo"))).Message,
            StringComparison.Ordinal);
    }

    [ShellFact]
    public void Open_Device_IsNotRead()
        => Assert.Contains(
            "/dev/zero: that is a device",
            Assert.Throws<PictureException>(() => CameraFolder.Open("/dev/zero")).Message, StringComparison.Ordinal);

    [ShellFact]
    public void Open_DescriptionThatIsAPipe_IsRefusedAndNotWaitedFor()
    {
        string pipe = _folder.File(CameraFolder.DescriptionFile);
        SamplePictures.MakePipe(pipe);

        Assert.Equal(
            [pipe + ": it is a pipe, not a file", pipe + ": it is a pipe, not a file"],
            [Assert.Throws<PictureException>(() => CameraFolder.Open(_folder.Path)).Message,
                Assert.Throws<PictureException>(() => CameraFolder.Open(pipe)).Message]);
    }

    private CameraFolder Open(string json)
    {
        File.WriteAllText(_folder.File(CameraFolder.DescriptionFile), json);
        return CameraFolder.Open(_folder.Path);
    }
}
