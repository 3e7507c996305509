use super::*;

fn file(map: &str) -> MazeFile {
    MazeFile {
        name: "test".into(),
        title: String::new(),
        summary: String::new(),
        source: String::new(),
        map: map.into(),
        goal_reward: 1.0,
        pit_reward: -1.0,
        step_reward: -0.1,
        bump_reward: -0.5,
        slip: 0.0,
    }
}

#[test]
fn steps_and_bumps_lead_where_they_should() {
    let maze = Maze::new(&file("S.\n#G\n")).expect("good");
    // States: 0 S, 1 floor, 2 G.
    for (state, action, next, reward) in
        [(0, 0, 0, -0.5), (0, 1, 1, -0.1), (0, 2, 0, -0.5), (1, 3, 0, -0.1), (1, 2, 2, 1.0)]
    {
        let outcomes = maze.mdp().outcomes(state, action);
        assert_eq!(outcomes, [Outcome { next, chance: 1.0, reward }], "{state} {action}");
    }
    assert!(maze.mdp().is_absorbing(2) && !maze.mdp().is_absorbing(0));
    assert_eq!(
        (maze.state_at(1, 1), maze.state_at(1, 0), maze.state_at(9, 9)),
        (Some(2), None, None)
    );
    assert_eq!(maze.state_name(1), "row 1, column 2");
}

#[test]
fn a_slip_goes_to_both_sides() {
    let maze = Maze::new(&MazeFile { slip: 0.2, ..file("...\nS.G\n...\n") }).expect("good");
    let start = maze.start();
    let chances: Vec<(usize, f64)> =
        maze.mdp().outcomes(start, 1).iter().map(|to| (to.next, to.chance)).collect();
    assert_eq!(chances, [(start + 1, 0.8), (start + 3, 0.1), (start - 3, 0.1)]);
}

#[test]
fn what_is_wrong_is_found_in_the_drawing() {
    for (map, message) in [
        ("..G\n", "`map` must have one start S, not 0"),
        ("S..\n", "`map` must have at least one goal G, not 0"),
        ("S.S\n..G\n", "`map`, line 1, column 3: a second start; a maze has one"),
        ("S.#G\n..#.\n", "`map`: no way leads from the start at line 1, column 1 to a goal"),
        (
            "S.G\n.?.\n",
            "`map`, line 2, column 2: `?` means nothing; use # wall, . floor, S start, G goal, \
            X pit, a to z for rooms",
        ),
    ] {
        let error = Maze::new(&file(map)).expect_err(map);
        assert_eq!(error.to_string(), message);
        assert_eq!(error.field(), "map");
    }
    let error = Maze::new(&MazeFile { slip: 1.5, ..file("SG") }).expect_err("slip");
    assert_eq!(error.to_string(), "`slip` must be from 0 to 1, not 1.5");
}

#[test]
fn knowledge_is_of_the_cells_own_surroundings() {
    let maze = Maze::new(&file("Sa#b\n.ab.\n..#G\n")).expect("good");
    let knowledge = maze.knowledge();
    let goal = &knowledge.features[0];
    let degree = |term: &str, state: usize| {
        goal.terms.iter().find(|degrees| degrees.term == term).expect("a term").degrees[state]
    };
    assert_eq!((degree("east", 0), degree("south", 0), degree("north", 0)), (1.0, 1.0, 0.0));
    assert_eq!((degree("near", 0), degree("far", 0)), (0.0, 1.0));
    assert!((knowledge.estimate[0] - 5.0).abs() < 1e-12);
    let gate = knowledge.gate.as_ref().expect("two rooms");
    assert_eq!(gate.names, ["room a", "room b"]);
    let goal = maze.state_at(2, 3).expect("the goal");
    assert_eq!((gate.behaviour[0], gate.behaviour[goal]), (0, 1));
    let door = maze.state_at(1, 1).expect("floor");
    assert!(knowledge.subgoals[door], "the cell before the next room");
    assert_eq!(knowledge.reflex[door], 1, "east is free and leads towards the goal");
}
