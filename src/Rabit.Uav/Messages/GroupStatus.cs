using System.Collections.Immutable;

namespace Rabit.Uav.Messages;

/// <summary>
/// The group that searches an area together, as one vehicle of it knows it. Posted by Mission Control once a second
/// where the vehicle is in a group. A plain value; the lists are immutable, and copies share them.
/// </summary>
public struct GroupStatus
{
    private ImmutableArray<GroupMember> _members;
    private ImmutableArray<ValidationTask> _validations;
    private ImmutableArray<FollowTask> _followings;
    private ImmutableArray<FollowedTrack> _followedTracks;

    /// <summary>The others, in the order of their system ids; also those that are received no more.</summary>
    public ImmutableArray<GroupMember> Members
    {
        readonly get => _members.IsDefault ? [] : _members;
        set => _members = value;
    }

    /// <summary>
    /// The targets that were announced for validation by a second vehicle, ours first. Where two vehicles announced
    /// one target, one of the two is closed without a result.
    /// </summary>
    public ImmutableArray<ValidationTask> Validations
    {
        readonly get => _validations.IsDefault ? [] : _validations;
        set => _validations = value;
    }

    /// <summary>
    /// The targets that move and that one vehicle follows, by their finders; also those that are not followed any more.
    /// </summary>
    public ImmutableArray<FollowTask> Followings
    {
        readonly get => _followings.IsDefault ? [] : _followings;
        set => _followings = value;
    }

    /// <summary>
    /// Which of our tracks are which of <see cref="Followings"/>, in the order of the tracks; also those that are there
    /// no more.
    /// </summary>
    public ImmutableArray<FollowedTrack> FollowedTracks
    {
        readonly get => _followedTracks.IsDefault ? [] : _followedTracks;
        set => _followedTracks = value;
    }

    /// <summary>MAVLink system id of the vehicle that divided the lanes; 0 for none yet.</summary>
    public byte DivisionAuthor { get; set; }

    /// <summary>Our own share of the lanes.</summary>
    public LaneShare OwnShare { get; set; }

    /// <summary>What we have left of it, metres.</summary>
    public double OwnMetresLeft { get; set; }

    /// <summary>How many lanes the area has.</summary>
    public int Lanes { get; set; }

    /// <summary>
    /// Reports, divisions and coverages of others that were refused: of our own system id, of a second vehicle with one
    /// system id, of other lanes, or of an author that is not the one to divide.
    /// </summary>
    public long Refused { get; set; }
}
